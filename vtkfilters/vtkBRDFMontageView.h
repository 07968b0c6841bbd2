#ifndef vtkBRDFMontageView_h
#define vtkBRDFMontageView_h
#include "vtkBRDFFiltersModule.h" // For export macro
#include "vtkBRDFView.h"
#include "vtkSmartPointer.h" // For vtkSmartPointer

#include <vector> // For std::vector

class vtkImageData;

/**
 * @class vtkBRDFMontageView
 * @brief Several pictures beside each other, each with a caption, under one title
 */
class VTKBRDFFILTERS_EXPORT vtkBRDFMontageView : public vtkBRDFView
{
public:
  static vtkBRDFMontageView* New();
  vtkTypeMacro(vtkBRDFMontageView, vtkBRDFView);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** Adds a picture (RGB, 8 bits, sRGB, first row at the bottom) with the line that is written below it. */
  void AddImage(vtkImageData* image, const std::string& caption);
  void RemoveAllImages();

  ///@{
  /** Pictures in a row; default 4. */
  vtkSetClampMacro(Columns, int, 1, 100);
  vtkGetMacro(Columns, int);
  ///@}

  ///@{
  /** A line below the title; empty by default. */
  vtkSetMacro(Note, std::string);
  vtkGetMacro(Note, std::string);
  ///@}

protected:
  vtkBRDFMontageView();
  ~vtkBRDFMontageView() override;
  void Build(int width, int height) override;

private:
  vtkBRDFMontageView(const vtkBRDFMontageView&) = delete;
  void operator=(const vtkBRDFMontageView&) = delete;

  struct Item
  {
    vtkSmartPointer<vtkImageData> Image;
    std::string Caption;
  };
  std::vector<Item> Items;
  int Columns = 4;
  std::string Note;
};
#endif
